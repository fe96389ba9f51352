// Keeps a fault of one part of the page from taking the others with it: Hold stays.
import { Component, type ComponentChildren } from "preact";
import { say } from "../words/words";

interface Props {
  children: ComponentChildren;
}

export class Fence extends Component<Props, { fault: string }> {
  override state = { fault: "" };

  override componentDidCatch(error: unknown): void {
    this.setState({ fault: error instanceof Error ? error.message : String(error) });
    console.error(error);
  }

  override render() {
    if (this.state.fault === "") return this.props.children;
    return (
      <div class="banner" role="alert">
        <p>{say("fault", { reason: this.state.fault })}</p>
        <button type="button" onClick={() => location.reload()}>
          {say("fault.reload")}
        </button>
      </div>
    );
  }
}
